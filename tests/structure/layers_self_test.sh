#!/bin/sh
# Plants violations, one at a time, in a small tree and demands that layers.sh finds each.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
mkdir -p "$tree/src/base" "$tree/src/image" "$tree/src/projection" "$tree/src/scene/mesh" "$tree/apps/tool" "$tree/bench/kernels"

plant() { printf '%s\n' "$2" >"$tree/$1"; }

restore() {
  plant src/base/error.hpp '#include <string>'
  plant src/image/image.hpp '#include "../base/error.hpp"'
  plant src/projection/camera.hpp '#include "../base/error.hpp"'
  plant src/scene/scene.cpp '#include "scene.hpp"'
  plant src/scene/mesh/mesh.hpp '#include "../../base/error.hpp"'
  plant src/scene/mesh/mesh.cpp '#include "../scene.hpp"'
  plant src/velum.hpp '#include "scene/scene.hpp"'
  plant apps/tool/main.cpp '#include <velum/velum.hpp>'
  plant bench/main.cpp '#include <velum/velum.hpp>'
  plant bench/kernels/main.cpp '#include <velum/pipeline/stages.hpp>'
  rm -rf "$tree/src/attic"
}

restore
"$here/layers.sh" "$tree" >/dev/null || { echo "a clean tree is refused"; exit 1; }

# must_find FILE LINE
must_find() {
  mkdir -p "$tree/$(dirname "$1")"
  plant "$1" "$2"
  if found=$("$here/layers.sh" "$tree"); then
    echo "layers.sh does not see $2 in $1"
    exit 1
  fi
  case "$found" in
    *"$1:1:"*) ;;
    *) echo "layers.sh fails for $2 in $1 but does not name the line: $found"; exit 1 ;;
  esac
  restore
}

must_find src/base/error.hpp '#include "../image/image.hpp"'
must_find src/image/image.hpp '#include "../projection/camera.hpp"'
must_find src/image/image.hpp '  #  include "../image/other.hpp"'
must_find src/scene/scene.cpp '#include "scene/scene.hpp"'
must_find src/scene/scene.cpp '#include "../attic/old.hpp"'
must_find src/scene/scene.cpp '#include <velum/velum.hpp>'
must_find src/scene/mesh/mesh.hpp '#include "../../raycast/search.hpp"'
must_find src/scene/mesh/mesh.hpp '#include "../../scene/scene.hpp"'
must_find src/scene/mesh/mesh.hpp '#include "../mesh/mesh.hpp"'
must_find src/scene/mesh/mesh.hpp '#include "../../../src/base/error.hpp"'
must_find src/attic/old.hpp '#include "older.hpp"'
must_find apps/tool/main.cpp '#include "../../src/scene/scene.hpp"'
must_find apps/tool/main.cpp '#include "velum/velum.hpp"'
must_find apps/tool/main.cpp '#include <src/scene/scene.hpp>'
must_find bench/main.cpp '#include <velum/pipeline/stages.hpp>'
echo "layers.sh finds every planted violation"
