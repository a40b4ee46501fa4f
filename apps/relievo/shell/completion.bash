# bash completion for relievo and relievo-viewer                                        -*- shell-script -*-
# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
#
# `relievo --words` lists all options, and runs once per shell: each line has a command, an option (a
# dot: its files), the kind of its value (flag, value, extensions, or / for folders), and words.

_relievo()
{
    local cur prev words cword
    # shellcheck disable=SC2034 # set by _init_completion
    local split
    _init_completion -s || return

    # The viewer asks the command, which lies beside it.
    local program=$1 command=${words[1]}
    if [[ ${program##*/} == relievo-viewer ]]; then
        program=${program%-viewer}
        command=relievo-viewer
    fi
    [[ ${_relievo_words-} ]] || _relievo_words=$("$program" --words 2>/dev/null)
    local of name takes more commands="--help --version" options="" files="" wanted="" values=""
    while read -r of name takes more; do
        if [[ $name == . && $of != relievo-viewer ]]; then commands+=" $of"; fi
        if [[ $of != "$command" ]]; then
            continue
        elif [[ $name == . ]]; then
            files=$takes
        else
            options+=" $name"
            if [[ $name == "$prev" && $takes != flag ]]; then
                wanted=$takes
                values=$more
            fi
        fi
    done <<<"$_relievo_words"

    if ((cword == 1)) && [[ $command != relievo-viewer ]]; then
        values=$commands
    elif [[ ! $wanted ]]; then
        if [[ $cur == -* || $files == none ]]; then values=$options; else wanted=$files; fi
    elif [[ $wanted != value && $cur == *[./]* ]]; then
        values="" # the path of a file, where words stand for others
    fi
    if [[ $values ]]; then
        if [[ "$values " == *": "* ]]; then compopt -o nospace; fi
        mapfile -t COMPREPLY < <(compgen -W "$values" -- "$cur")
        [[ $cur != *:* ]] || __ltrim_colon_completions "$cur"
    elif [[ $wanted == / ]]; then
        _filedir -d
    elif [[ $wanted && $wanted != value ]]; then
        _filedir "@($wanted)"
    fi
} && complete -F _relievo relievo relievo-viewer
