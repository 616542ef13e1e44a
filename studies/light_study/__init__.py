# SPDX-License-Identifier: Apache-2.0
"""Parts of the study of growth in the light: trees, expectations, figures."""
