// SPDX-License-Identifier: Apache-2.0
// The sun in the scene, and the values that the dial writes.
import { rounded } from '../values/arithmetic.ts';
import type { Json } from '../values/json.ts';
import { member_of } from '../values/path.ts';
import type { SkyPlace } from './sun_math.ts';
import {
  date_of_day,
  day_of_date,
  day_text,
  daylight,
  days_of_year,
  hour_of,
  hour_text,
  sun_place,
} from './sun_math.ts';

export interface SunState {
  /// fixed: a position; day: an hour of a day; season: several days; clock: by a local clock; none: without a sun;
  /// other: with expressions.
  kind: 'fixed' | 'day' | 'season' | 'clock' | 'none' | 'other';
  latitude: number | null;
  place: SkyPlace | null; // position of a fixed sun
  day: number; // for a season, its middle day
  days: [number, number] | null; // first and last day of a season
  hour: number;
  every_hours: number | null; // hours between positions of a day, if the light of the whole day counts
}

export const kNoLatitude = 50; // degrees; shown until a latitude is given

export function sun_state(scene: Json | undefined): SunState {
  const sun = member_of(scene, 'sun');
  const of = (name: string): Json | undefined => member_of(sun, name);
  const number = (name: string): number | null => (typeof of(name) === 'number' ? (of(name) as number) : null);
  const latitude = member_of(scene, 'latitude');
  const days = of('days');
  const ends =
    Array.isArray(days) && days.length === 2 && days.every((one) => typeof one === 'number')
      ? (days as [number, number])
      : null;
  const date = of('date');
  const day = typeof date === 'string' ? day_of_date(date) : number('day');
  const [azimuth, altitude] = [number('azimuth'), number('altitude')];
  const state: SunState = {
    kind: 'other',
    latitude: typeof latitude === 'number' ? latitude : null,
    place: azimuth !== null && altitude !== null ? { azimuth, altitude } : null,
    day: day ?? (ends ? middle_of(ends) : 172),
    days: ends,
    hour: hour_of(of('time')) ?? hour_of(of('hour')) ?? 12,
    every_hours: number('every_hours') ?? (ends ? 1 : null),
  };
  if (sun === undefined) return { ...state, kind: 'none' };
  if (state.place) return { ...state, kind: 'fixed' };
  if (of('time') !== undefined)
    return { ...state, kind: day !== null && hour_of(of('time')) !== null ? 'clock' : 'other' };
  if (ends) return { ...state, kind: 'season' };
  const hour = of('hour');
  return { ...state, kind: day !== null && (hour === undefined || hour_of(hour) !== null) ? 'day' : 'other' };
}

/// Returns the middle day of a season, which may continue into the next year.
function middle_of([first, last]: [number, number]): number {
  const end = last < first ? last + 365 : last;
  return ((Math.round((first + end) / 2) - 1) % 365) + 1;
}

/// Returns the values that set the day and the hour of the sun, in the form of the scene.
export function with_time(scene: Json | undefined, state: SunState, day: number, hour: number): Record<string, Json> {
  const sun = member_of(scene, 'sun');
  const held = Math.min(24, Math.max(0, hour));
  const is_clock = state.kind === 'clock';
  const row = is_clock ? 'scene.sun.time' : 'scene.sun.hour';
  const is_text = typeof member_of(sun, is_clock ? 'time' : 'hour') === 'string';
  const values: Record<string, Json> = { [row]: is_text ? hour_text(held) : rounded(held, 0.05) };
  if (state.kind === 'season' || Math.round(day) === Math.round(state.day)) return values;
  const year = year_of(scene);
  if (year !== null) values['scene.sun.date'] = date_of_day(Math.min(day, days_of_year(year)), year);
  else values['scene.sun.day'] = Math.round(day);
  return values;
}

/// Returns the year of the sun's date, or null if the scene gives the day by its number.
export function year_of(scene: Json | undefined): number | null {
  const date = member_of(member_of(scene, 'sun'), 'date');
  return typeof date === 'string' ? Number(date.slice(0, 4)) : null;
}

/// Returns the values that set the position of a fixed sun.
export function with_place({ azimuth, altitude }: SkyPlace): Record<string, Json> {
  return {
    'scene.sun.azimuth': rounded(((azimuth % 360) + 360) % 360, 0.5),
    'scene.sun.altitude': rounded(Math.min(90, Math.max(-90, altitude)), 0.5),
  };
}

/// A panel of the sun: the scene, its sun, and the effects of changes.
export interface SunActions {
  scene: Json | undefined;
  state: SunState;
  drag: (values: Record<string, Json>) => void;
  commit: (values: Record<string, Json>) => void;
  cancel: () => void;
}

/// Returns the position of the sun in the scene. A clock differs from solar time; the server computes that.
export function place_of(state: SunState): SkyPlace {
  return state.place ?? sun_place(state.latitude ?? kNoLatitude, state.day, state.hour);
}

/// Returns the position of the sun as text.
export function said_of(state: SunState, sun: SkyPlace): string {
  const place = `azimuth ${Math.round(sun.azimuth)}°, altitude ${Math.round(sun.altitude)}°`;
  if (state.kind === 'fixed') return place;
  const light = daylight(state.latitude ?? kNoLatitude, state.day);
  const day = light ? `up from ${hour_text(light[0])} to ${hour_text(light[1])}` : 'does not rise';
  return `${day_text(state.day)}, ${hour_text(state.hour)}: ${place}; ${day}`;
}
