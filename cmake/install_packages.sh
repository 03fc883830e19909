#!/usr/bin/env bash
# Installs the Debian packages of cmake/packages.txt that are missing, and those of the lists named;
# silent when none is.
set -eu
lists=("$(dirname "$0")/packages.txt" "$@")

if ! command -v dpkg-query > /dev/null; then
  echo "not a Debian system: make sure that what cmake/packages.txt names is installed"
  exit 0
fi

wanted=$(cat "${lists[@]}")  # fails where a list is missing
missing=()
for package in $wanted; do
  if ! dpkg-query --show --showformat='${Status}' "$package" 2> /dev/null | grep -q 'ok installed'
  then
    missing+=("$package")
  fi
done
[ ${#missing[@]} -gt 0 ] || exit 0

if [ "$(id -u)" -ne 0 ]; then
  echo "missing packages; run:  sudo apt-get install ${missing[*]}" >&2
  exit 1
fi
echo "installing ${missing[*]}"
export DEBIAN_FRONTEND=noninteractive
# On a fresh machine another program may be installing still, and hold the lock for some minutes.
apt-get update -qq
apt-get -o DPkg::Lock::Timeout=600 install --yes -qq --no-install-recommends "${missing[@]}"
