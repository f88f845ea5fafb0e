# Script of adore_embed: writes each file as byte array into one C++ source.
string(REPLACE "|" ";" PAIRS "${PAIRS}")
set(arrays "")
set(table "")
set(index 0)
foreach(pair ${PAIRS})
  string(REGEX MATCH "^[^=]*" name ${pair})
  string(REGEX REPLACE "^[^=]*=" "" file ${pair})
  file(READ ${file} hex HEX)
  string(LENGTH "${hex}" digits)
  math(EXPR size "${digits} / 2")
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${hex}")
  string(APPEND arrays "const unsigned char data${index}[] = {${bytes}0};\n")
  string(APPEND table "    {\"${name}\", {reinterpret_cast<const char*>(data${index}), ${size}}},\n")
  math(EXPR index "${index} + 1")
endforeach()
file(WRITE ${OUTPUT}.tmp
     "#include \"base/resources.hpp\"\n\nnamespace adore::resources {\nnamespace {\n${arrays}}  // namespace\n"
     "std::span<const Resource> all() {\n  static const Resource table[] = {\n${table}  };\n  return table;\n}\n"
     "}  // namespace adore::resources\n")
file(COPY_FILE ${OUTPUT}.tmp ${OUTPUT} ONLY_IF_DIFFERENT)
