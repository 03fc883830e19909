#!/bin/sh
# Meshes every molecule given and checks each written file again: mesh_all.sh FOLDER MOLECULE ...
# What cannot be meshed is named, and the others are meshed all the same. As `morskin batch` does, a
# mesh takes all of its molecule's name, so a.pdb and a.cif do not collide; two of one name are
# refused.
set -eu
case ${1--} in -*)  # a folder of such a name is ./-name
  echo "usage: mesh_all.sh FOLDER MOLECULE ...; there are no options" >&2
  exit 2 ;;
esac
folder=$1
shift
mkdir -p "$folder"
twice=$(for molecule; do basename -- "$molecule"; done | sort | uniq -d)
if [ -n "$twice" ]; then
  echo "mesh_all.sh: several molecules are called $twice" >&2
  exit 2
fi

for molecule; do
  case $molecule in -*) molecule=./$molecule ;; esac  # a file, no option
  name=$(basename "$molecule")
  mesh=$folder/$name.ply
  code=0
  morskin mesh "$molecule" -o "$mesh" -C 0.2 --report "${mesh%.ply}.json" --quiet || code=$?
  case $code in
    0) morskin check "$mesh" --against "$molecule" > /dev/null
       echo "$name: certified, and again from the file" ;;
    3 | 4) echo "$name: no molecule with a smooth skin" ;;
    5) echo "$name: not certified, left as $mesh.unverified" ;;
    6) echo "$name: a limit was reached" ;;
    *) exit "$code" ;;
  esac
done
