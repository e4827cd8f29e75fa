# Bash completion for `restrip`: subcommands, options and their values, as listed by the program's help; otherwise file
# names.
# Installed as share/bash-completion/completions/restrip.
_restrip() {
  local program=${COMP_WORDS[0]} current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} words
  COMPREPLY=()
  if ((COMP_CWORD == 1)); then
    words=$("$program" --help 2>/dev/null | awk '/^Subcommands:/ { found = 1; next } found && /^  [a-z]/ { print $1 }')
    [[ $current == -* ]] && words="--help --version"
  else
    local help
    help=$("$program" "${COMP_WORDS[1]}" --help 2>/dev/null)
    if [[ $current == -* ]]; then
      words=$(awk '/^  -/ { n = split($1, names, ","); for (i = 1; i <= n; ++i) print names[i] }' <<<"$help")
    else  # a|b|c after the option
      words=$(awk -v option="$before" '/^  -/ {
        n = split($1, names, ",")
        for (i = 1; i <= n; ++i) if (names[i] == option && $2 ~ /\|/) { gsub(/\|/, "\n", $2); print $2 }
      }' <<<"$help")
    fi
  fi
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
}
# bash completes file names if nothing matches.
complete -o bashdefault -o default -F _restrip restrip
