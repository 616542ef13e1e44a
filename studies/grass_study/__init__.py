# SPDX-License-Identifier: Apache-2.0
"""Parts of the study of grass leaves: measured leaves, fits, ages, levels, forces, light, expectations, figures."""
