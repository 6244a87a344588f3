# cmake -DPAGE=FILE -DOUT=FILE -P embed.cmake: a file's bytes as a C++ source, which programs are linked with.
file(READ ${PAGE} bytes HEX)
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "\\\\x\\1" bytes "${bytes}")
string(LENGTH "${bytes}" length)
set(lines "")
foreach(at RANGE 0 ${length} 16384)
  string(SUBSTRING "${bytes}" ${at} 16384 line)
  string(APPEND lines "    \"${line}\"\n")
endforeach()
file(WRITE ${OUT} "// Made by tools/viewer/embed.cmake.
extern \"C\" {
extern const char trophic_viewer_page[];
extern const unsigned long trophic_viewer_page_size;
const char trophic_viewer_page[] =
${lines};
const unsigned long trophic_viewer_page_size = sizeof(trophic_viewer_page) - 1;
}
")
