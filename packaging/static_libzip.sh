#!/usr/bin/env bash
# Makes libzip.a in a folder, from Debian's source package: Debian has libzip as a shared library
# only. Without the encryption and compressions that no mesh file uses.   static_libzip.sh FOLDER
set -euo pipefail
mkdir -p "$1/apt/lists"
cd "$1"
[ ! -e libzip.a ] || exit 0

# A list of sources and a state of apt's own: neither root nor the system's lists are needed.
codename=$(. /etc/os-release && echo "$VERSION_CODENAME")
echo "deb-src http://deb.debian.org/debian $codename main" > apt/sources.list
options=(-o "Dir::Etc::SourceList=$PWD/apt/sources.list" -o Dir::Etc::SourceParts=-
         -o "Dir::State::Lists=$PWD/apt/lists" -o "Dir::Cache=$PWD/apt" -q)
apt-get "${options[@]}" update
apt-get "${options[@]}" source libzip

cmake -S libzip-*/ -B libzip-build -D BUILD_SHARED_LIBS=OFF -D CMAKE_BUILD_TYPE=Release \
  -D ENABLE_COMMONCRYPTO=OFF -D ENABLE_GNUTLS=OFF -D ENABLE_MBEDTLS=OFF -D ENABLE_OPENSSL=OFF \
  -D ENABLE_BZIP2=OFF -D ENABLE_LZMA=OFF -D ENABLE_ZSTD=OFF
cmake --build libzip-build --target zip --parallel "$(nproc)"
cp libzip-build/lib/libzip.a .
