#!/usr/bin/env bash
# Makes libarchive.a in a folder, from Debian's source package: Debian's own needs more than Debian
# has as static libraries. Without the encryption and compressions that no mesh file and no archive
# of molecules uses but gzip's.                                       static_libraries.sh FOLDER
set -euo pipefail
mkdir -p "$1/apt/lists"
cd "$1"
[ ! -e libarchive.a ] || exit 0

# A list of sources and a state of apt's own: neither root nor the system's lists are needed.
codename=$(. /etc/os-release && echo "$VERSION_CODENAME")
echo "deb-src http://deb.debian.org/debian $codename main" > apt/sources.list
options=(-o "Dir::Etc::SourceList=$PWD/apt/sources.list" -o Dir::Etc::SourceParts=-
         -o "Dir::State::Lists=$PWD/apt/lists" -o "Dir::Cache=$PWD/apt" -q)
apt-get "${options[@]}" update
apt-get "${options[@]}" source libarchive

cmake -S libarchive-*/ -B libarchive-build -D BUILD_SHARED_LIBS=OFF -D CMAKE_BUILD_TYPE=Release \
  -D ENABLE_OPENSSL=OFF -D ENABLE_NETTLE=OFF -D ENABLE_LIBB2=OFF -D ENABLE_LZ4=OFF \
  -D ENABLE_LZMA=OFF -D ENABLE_ZSTD=OFF -D ENABLE_BZip2=OFF -D ENABLE_LIBXML2=OFF \
  -D ENABLE_EXPAT=OFF -D ENABLE_PCREPOSIX=OFF -D ENABLE_ACL=OFF -D ENABLE_ICONV=OFF \
  -D ENABLE_TEST=OFF -D ENABLE_TAR=OFF -D ENABLE_CPIO=OFF -D ENABLE_CAT=OFF -D ENABLE_WERROR=OFF
cmake --build libarchive-build --target archive_static --parallel "$(nproc)"
cp libarchive-build/libarchive/libarchive.a .
