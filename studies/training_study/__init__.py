# SPDX-License-Identifier: Apache-2.0
"""Parts of the study of trained trees: poles, open vases, cuts to buds, espaliers, cordons, expectations, figures."""
