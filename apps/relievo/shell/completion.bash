# bash completion for relievo and relievo-viewer                                        -*- shell-script -*-
# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The options are those of `relievo --help`, which is asked once in a shell.

_relievo()
{
    local cur prev words cword outputs="" more=""
    # shellcheck disable=SC2034 # set by _init_completion
    local split
    _init_completion -s || return

    # The viewer's words are those of `relievo render`, which lies beside it.
    local program=$1
    if [[ ${program##*/} == relievo-viewer ]]; then
        program=${program%-viewer}
        words=("$program" render "${words[@]:1}")
        outputs='@(--png|--exr|--report|--layers|--hdr|--lens|--transparent|--certify)' # the window has its own
        more='--once --help --version'
    elif ((cword == 1)); then
        mapfile -t COMPREPLY < <(compgen -W 'render dataset visible sun cave stages bench --help --version' -- "$cur")
        return
    fi

    # A data set is of a scene of render, but poses and files of its own are in the place of these.
    if [[ ${words[1]} == dataset ]]; then
        outputs='@(--camera|--parallel-scale|--clip|--times|--png|--exr|--report|--layers|--hdr|--transparent|--certify)'
    fi

    [[ ${_relievo_help-} ]] || _relievo_help=$("$program" --help 2>/dev/null)
    local line part="" options=$more wants_value=""
    while IFS= read -r line; do
        case $line in
            'render '* | 'dataset '* | 'visible '* | 'sun '* | 'cave '* | 'stages '* | 'bench '* | 'Options '*) part=${line%% *} ;;
            '  -'*)
                if [[ $part == "${words[1]}" || (${words[1]} == dataset && $part == render) ]]; then
                    line=${line#  }
                    # shellcheck disable=SC2053 # a pattern
                    [[ $outputs && $part == render && ${line%% *} == $outputs ]] || options+=" ${line%% *}"
                    [[ $line == "$prev "[^\ ]* ]] && wants_value=1
                fi
                ;;
        esac
    done <<<"$_relievo_help"

    local meshes='@(vt[puirsk]|vtm|vtmb|pvt[puirs]|stl|ply|obj|off|gltf|glb|bvh|dae|fbx|iqm|ms3d|x)'
    local images='@(png|jpg|jpeg|tif|tiff|bmp|hdr|exr)'
    local values=""
    case $prev in
        --shading) values='flat gouraud phong pbr' ;;
        --preset) values='studio town print' ;;
        --colormap) values='viridis cool-warm grey hot rainbow' ;;
        --shadows) values='off map forward warped exact' ;;
        --skin) values='linear dual-quaternion key-matrix off' ;;
        --relief) values='off parallax steep occlusion relief' ;;
        --texture-coordinates) values='box plane sphere' ;;
        --tone) values='clamp simple reinhard reinhard-rgb' ;;
        --exposure) values='auto' ;;
        --up) values='x y z' ;;
        --content) values='mask density labels' ;;
        --format) values='bop coco nerf npz' ;;
        --objects) values='file actor block' ;;
        --poses)
            values='orbit: random:'
            compopt -o nospace
            ;;
        --light)
            values='sun: spot: point:'
            compopt -o nospace
            ;;
        --lens)
            [[ $cur == *[./]* ]] && { _filedir '@(json|yml|yaml|xml|txt|gz)'; return; }
            values='pinhole brown: fisheye division: equirectangular cube orthographic'
            ;;
        --png) _filedir png; return ;;
        --exr) _filedir exr; return ;;
        --report) _filedir json; return ;;
        -o | --cloud)
            if [[ ${words[1]} == cave ]]; then _filedir vti; else _filedir vtp; fi
            return
            ;;
        --normal-map | --height-map | --environment) _filedir "$images"; return ;;
        --lamps | --fog | --markers) _filedir "$meshes"; return ;;
        --allow-folder | --beside | --out) _filedir -d; return ;;
        *) [[ $wants_value ]] && return ;;
    esac
    [[ ! $values && ($cur == -* || ${words[1]} != @(render|dataset|visible|sun)) ]] && values=$options
    if [[ $values ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$values" -- "$cur")
        [[ $cur != *:* ]] || __ltrim_colon_completions "$cur"
    elif [[ ${words[1]} == @(render|dataset|visible|sun) ]]; then
        _filedir "$meshes"
    fi
} && complete -F _relievo relievo relievo-viewer
