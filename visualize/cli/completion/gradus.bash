# Completion of the gradus command in bash; `gradus completion bash` prints it.
# What may come next is asked of the program itself, so that it always knows its own topics and flags.

_gradus() {
  local words=() typed cut rest=${COMP_LINE:0:COMP_POINT} blank piece line ending i plain=yes
  # Bash takes words apart at = and : as well: what no blank parts is put together again
  for ((i = 0; i <= COMP_CWORD; ++i)); do
    blank=${rest%%[![:space:]]*}
    rest=${rest#"$blank"}
    piece=${COMP_WORDS[i]}
    ((i < COMP_CWORD)) || piece=$rest
    rest=${rest#"$piece"}
    if [[ -n $blank || $i -eq 0 ]]; then words+=("$piece"); else words[-1]+=$piece; fi
  done
  typed=${words[-1]}
  # It puts the answer in the place of what stands behind the last of them
  cut=$typed
  [[ $COMP_WORDBREAKS != *=* ]] || cut=${cut##*=}
  [[ $COMP_WORDBREAKS != *:* ]] || cut=${cut##*:}

  local program=${words[0]/#\~/$HOME}
  [[ -z ${BASH_ALIASES[$program]-} ]] || program=${BASH_ALIASES[$program]}
  local lines=()
  # Not quoted: an alias may be several words
  mapfile -t lines < <($program completion --next -- "${words[@]:1}" 2>/dev/null)

  COMPREPLY=()
  for line in "${lines[@]}"; do
    [[ $line != $'\t'* ]] || plain=no
  done
  [[ $plain == yes ]] || compopt -o filenames 2>/dev/null
  for line in "${lines[@]}"; do
    case $line in
      $'\tfolders')
        mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -d -- "$cut")
        ;;
      $'\tfiles')
        mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -f -- "$cut")
        ;;
      $'\tfiles\t'*)
        mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -d -- "$cut")
        for ending in ${line#$'\tfiles\t'}; do
          mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -f -X "!*$ending" -- "$cut")
        done
        ;;
      *)
        piece=${line%%$'\t'*}
        piece=${piece#"${typed%"$cut"}"}
        # Names of files are quoted by bash, other words here
        [[ $plain == no ]] || printf -v piece %q "$piece"
        COMPREPLY+=("$piece")
        ;;
    esac
  done
}

complete -F _gradus gradus
