// SPDX-License-Identifier: MIT
// Takes the place of the viewer's page in a build without it (-DTROPHIC_VIEWER=OFF).
extern "C" {
extern const char trophic_viewer_page[];
extern const unsigned long trophic_viewer_page_size;
const char trophic_viewer_page[] = "";
const unsigned long trophic_viewer_page_size = 0;
}
