// SPDX-License-Identifier: MIT
// Never built: its compile command is the one by which each header is compiled alone.
