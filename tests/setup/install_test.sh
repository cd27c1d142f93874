#!/usr/bin/env bash
# .ci/setup on a machine that lacks some packages, with dpkg and apt played by stand-ins: what is missing is installed, and
# only that, although dpkg-query fails when it does not know a name.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cat > "$scratch/dpkg-query" <<'END'
#!/bin/sh
echo "installed g++"
echo "not-installed cmake"
exit 1
END
cat > "$scratch/apt-get" <<END
#!/bin/sh
echo "\$@" >> "$scratch/calls"
END
printf '#!/bin/sh\nexec "$@"\n' > "$scratch/sudo"
chmod +x "$scratch"/*
printf '# a list\ng++\ncmake\nlibnew-dev\n' > "$scratch/packages.txt"
PATH=$scratch:$PATH bash -euo pipefail -c 'source "$1/.ci/setup"; glint_install "$2"' - "$root" "$scratch"
grep -q ' update$' "$scratch/calls" || { echo "the lists were not updated"; cat "$scratch/calls"; exit 1; }
grep -q ' install cmake libnew-dev$' "$scratch/calls" || { echo "not what is missing:"; cat "$scratch/calls"; exit 1; }
