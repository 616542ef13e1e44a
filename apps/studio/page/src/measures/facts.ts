// SPDX-License-Identifier: Apache-2.0
// Published measurements of real plants, each with its source. A plant outside of a range is not wrong: it only differs
// from what the source has measured.

export interface Fact {
  low: number;
  high: number;
  of: string; // what was measured, and on which plants
  source: string;
}

const kWalnut = 'the walnut of OpenAlea’s MTG package (noylum2.mtg), 6,427 digitised segments';

export const kFacts: Readonly<Record<string, readonly Fact[]>> = {
  slenderness: [
    {
      low: 20,
      high: 75,
      of: 'most city trees',
      source: 'E. G. McPherson, N. S. van Doorn, P. J. Peper: Urban tree database (2016), 13,806 trees',
    },
  ],
  pipe_exponent: [
    {
      low: 1.5,
      high: 2.8,
      of: 'natural trees',
      source:
        'J. Gao, M. G. Newberry: Scaling in branch thickness and the fractal aesthetic of trees, PNAS Nexus 4 (2025)',
    },
  ],
  leaf_area_index: [
    {
      low: 2,
      high: 7,
      of: 'vegetation of the whole earth, mean and one standard deviation to each side',
      source:
        'G. P. Asner, J. M. O. Scurlock, J. A. Hicke: Global synthesis of leaf area index observations, Global Ecology and Biogeography 12 (2003), 1,008 measurements',
    },
  ],
  bifurcation_ratio: [{ low: 2.7, high: 3.6, of: 'a walnut, from stream to stream', source: kWalnut }],
  branching_angle_median: [{ low: 18, high: 110, of: 'a walnut, 5 to 95 % of its laterals', source: kWalnut }],
  area_ratio_median: [{ low: 0.81, high: 1.36, of: 'a walnut, 5 to 95 % of its forks from 2 cm', source: kWalnut }],
};
