# SPDX-License-Identifier: Apache-2.0
"""What scanners see of a digitised walnut, against what is there."""
