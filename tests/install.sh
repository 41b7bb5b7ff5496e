# SPDX-License-Identifier: BSD-3-Clause
# Sourced by tests/run.sh, bench/run.sh and .ci/run: installs the Debian packages named, where they are missing.

brink_packages="g++ cmake ninja-build libeigen3-dev libfcl-dev libccd-dev doctest-dev libbenchmark-dev libcli11-dev
libfmt-dev libqhull-dev libboost-dev libmpfr-dev libgmp-dev libhwy-dev libtbb-dev libbullet-dev
gnuplot-nox"

install_missing() { # <package>...
    local missing=() package sudo=()
    for package; do
        [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2> /dev/null)" = installed ] || missing+=("$package")
    done
    [ ${#missing[@]} -gt 0 ] || return 0
    [ "$(id -u)" = 0 ] || sudo=(sudo)
    echo "Installing: ${missing[*]}"
    "${sudo[@]}" apt-get update -qq
    "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" \
        > /dev/null
}
