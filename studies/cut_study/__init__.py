# SPDX-License-Identifier: Apache-2.0
"""Parts of the study of cut leaders: trees, the cut and its table, adaptations, growth, expectations, figures."""
