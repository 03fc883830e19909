# Writes a C++ file that holds the bytes of another, as a function. Run at build time:
#   cmake -D FILE=... -D OUT=... -D HEADER=... -D NAMESPACE=... -D FUNCTION=... -P embed.cmake
file(READ "${FILE}" hex HEX)
string(LENGTH "${hex}" digits)
math(EXPR count "${digits} / 2")
string(REGEX REPLACE "(................................................................)" "\\1\n"
       hex "${hex}")
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," hex "${hex}")
file(WRITE "${OUT}" "#include \"${HEADER}\"

namespace ${NAMESPACE} {
namespace {
const unsigned char bytes[] = {
${hex}};
}  // namespace

std::string_view ${FUNCTION}() {
  return {reinterpret_cast<const char*>(bytes), ${count}};
}
}  // namespace ${NAMESPACE}
")
