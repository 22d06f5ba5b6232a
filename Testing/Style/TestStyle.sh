#!/bin/sh
# TestStyle.sh REPOSITORY: .ci/style, in a repository of its own, looks at what git tracks, and at nothing else.
set -eu
repository=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
unset GIT_DIR GIT_INDEX_FILE GIT_WORK_TREE # of a hook that runs this
mkdir "$folder/.ci"
cp "$repository/.ci/style" "$folder/.ci"
cp "$repository/.clang-format" "$repository/.codespellrc" "$folder"
cd "$folder"

misspelt=$(printf "b%s" u) # in parts: this file is looked at too
passes() { .ci/style > said.txt 2>&1 || { echo "$1: fails"; cat said.txt; exit 1; }; }
fails() {
  if .ci/style > said.txt 2>&1; then echo "$1: passes"; exit 1; fi
  grep -q "$2" said.txt || { echo "$1: fails, but not for $2"; cat said.txt; exit 1; }
}
untrack() { git rm --quiet -f --cached "$1"; }

git init --quiet .
printf 'int one();\n' > one.cpp
printf 'The words are right.\n' > words.md
git add .ci .clang-format .codespellrc one.cpp words.md
passes "what is right"

printf '<VTKFile>%s</VTKFile>\n' "$misspelt" > demo.vtu
printf 'int  two( );\n' > two.cpp
mkdir build
printf '%s\n' "$misspelt" > build/words.md
passes "with files that git does not track"

for file in demo.vtu build/words.md; do
  git add -f "$file"
  fails "a word of $file" "$misspelt"
  untrack "$file"
done
git add two.cpp
fails "the format of two.cpp" clang-format
untrack two.cpp
mkdir Data
printf 'solid %s\nendsolid\n' "$misspelt" > Data/names.stl
git add Data
passes "a word of data, which .codespellrc leaves out"

git add demo.vtu
rm -rf .git
passes "a folder without git"
