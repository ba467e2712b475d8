#compdef gradus
# Completion of the gradus command in zsh; `gradus completion zsh` prints it.
# What may come next is asked of the program itself, so that it always knows its own topics and flags.

_gradus() {
  local -a lines candidates endings
  local line before="${(Q)PREFIX}"
  lines=("${(@f)$(_call_program gradus ${(q)words[1]} completion --next -- \
    ${(q)${(Q)words[2,CURRENT-1]}} ${(q)before} 2>/dev/null)}")
  for line in $lines; do
    case $line in
      ($'\t'*) ;;
      (?*) candidates+=("${${line%%$'\t'*}//:/\\:}:${line#*$'\t'}") ;;
    esac
  done
  (( $#candidates )) && _describe -V 'gradus' candidates
  # Of --output=FILE the part behind = is the file
  [[ $PREFIX == --*=* ]] && compset -P '*='
  for line in $lines; do
    case $line in
      ($'\tfolders') _path_files -/ ;;
      ($'\tfiles') _files ;;
      ($'\tfiles\t'*)
        endings=(${=line#$'\tfiles\t'})
        # Not _files, which offers every file where none has such an ending
        _path_files -g "${(j: :)endings/#/*}"
        _path_files -/
        ;;
    esac
  done
}

if [[ $funcstack[1] == _gradus ]]; then
  _gradus "$@"
else
  compdef _gradus gradus
fi
