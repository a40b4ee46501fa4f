# bash completion for relievo                                        -*- shell-script -*-
# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause

_relievo()
{
    local cur prev words cword
    # shellcheck disable=SC2034 # set by _init_completion
    local split
    _init_completion -s || return

    local meshes='@(vt[puirsk]|vtm|vtmb|pvt[puirs]|stl|ply|obj|off|gltf|glb)'
    local images='@(png|jpg|jpeg|tif|tiff|bmp|hdr|exr)'
    local render='--size --camera --view-angle --parallel-scale --clip --shading --preset --color-by
        --range --colormap --scalar-bar --color --opacity --edges --background --light --lamps --shadows
        --shadow-size --normal-map --height-map --relief --texture-coordinates --environment
        --reflectivity --skybox --up --fog --markers --deferred --stage --tone --exposure --layers --png
        --exr --hdr --report'
    local cave='-o --size --seed --width --scale --vertical-scale --up --origin --spacing --content'
    local bench='--out --redraw'

    local values=
    case $prev in
        --shading) values='flat gouraud phong pbr' ;;
        --preset) values='studio town print' ;;
        --colormap) values='viridis cool-warm grey hot rainbow' ;;
        --shadows) values='off map forward warped exact' ;;
        --relief) values='off parallax steep occlusion relief' ;;
        --texture-coordinates) values='box plane sphere' ;;
        --tone) values='clamp simple reinhard reinhard-rgb' ;;
        --exposure) values='auto' ;;
        --up) values='x y z' ;;
        --content) values='mask density labels' ;;
        --light)
            values='sun: spot: point:'
            compopt -o nospace
            ;;
        --png) _filedir png; return ;;
        --exr) _filedir exr; return ;;
        --report) _filedir json; return ;;
        -o) _filedir vti; return ;;
        --normal-map | --height-map | --environment) _filedir "$images"; return ;;
        --lamps | --fog | --markers) _filedir "$meshes"; return ;;
        --out | --redraw) _filedir -d; return ;;
        --size | --camera | --view-angle | --parallel-scale | --clip | --color-by | --range | --color | \
            --opacity | --background | --shadow-size | --reflectivity | --stage | --layers | --seed | \
            --width | --scale | --vertical-scale | --origin | --spacing)
            return
            ;;
    esac
    if [[ $values ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$values" -- "$cur")
        __ltrim_colon_completions "$cur"
        return
    fi

    case ${words[1]} in
        render) [[ $cur == -* ]] && values=$render ;;
        cave) values=$cave ;;
        bench) [[ $cur == -* ]] && values=$bench ;;
        stages) return ;;
        *) ((cword == 1)) && values='render cave stages bench --help --version' ;;
    esac
    if [[ $values ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$values" -- "$cur")
    elif [[ ${words[1]} == render ]]; then
        _filedir "$meshes"
    fi
} && complete -F _relievo relievo
