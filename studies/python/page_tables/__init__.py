# SPDX-License-Identifier: MIT
"""Tables and figures of the documents, a module for each subject."""
