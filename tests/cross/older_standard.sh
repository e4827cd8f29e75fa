# older_standard.sh COMPILER LIBRARY TABLES: each public header, included alone by a compiler of C++17, says once that restrip
# needs C++20, and the preprocessor finds nothing else wrong. Adapters are left out: they include packages that may be missing.
compiler=$1 library=$2 tables=$3
cd "$library" || exit 1
seen=0 wrong=0
for header in $(find restrip -name '*.hpp' ! -path '*/impl/*' ! -path '*/adapters/*' | sort); do
  errors=$(echo "#include \"$header\"" | "$compiler" -std=c++17 -E -x c++ -I . -I "$tables" -o /dev/null - 2>&1 | grep 'error:')
  seen=$((seen + 1))
  case $errors in
    *error:*error:*) ;;
    *'restrip needs C++20'*) continue ;;
  esac
  wrong=$((wrong + 1))
  echo "$header: one error about C++20 expected, but: ${errors:-no error}"
done
echo "$seen headers, $wrong wrong"
[ "$seen" -ge 45 ] && [ "$wrong" -eq 0 ]
