// SPDX-License-Identifier: Apache-2.0
// The position of the sun, by the library's formula (meristem/scene/light/sun.cpp), and the inverse from a position to
// day and hour. Degrees; azimuth from north over east; hours of true solar time.

export interface SkyPlace {
  azimuth: number;
  altitude: number;
}

const kRadians = Math.PI / 180;
const kMaxDeclination = Math.asin(0.3978) / kRadians;
export const kSolstices = { summer: 172, winter: 355, equinox: 80 };
export const kDaysOfYear = 365;

export function declination(day: number): number {
  const angle = (2 * Math.PI * day) / 365.25;
  return Math.asin(0.3978 * Math.sin(angle - 1.4 + 0.0355 * Math.sin(angle - 0.0489))) / kRadians;
}

export function sun_place(latitude: number, day: number, hour: number): SkyPlace {
  return place_at(latitude, declination(day), hour);
}

function place_at(latitude: number, sun: number, hour: number): SkyPlace {
  const [phi, delta, turn] = [latitude * kRadians, sun * kRadians, 15 * (hour - 12) * kRadians];
  const along = Math.cos(delta) * Math.cos(turn);
  const north = Math.sin(delta) * Math.cos(phi) - along * Math.sin(phi);
  const up = Math.sin(delta) * Math.sin(phi) + along * Math.cos(phi);
  const east = -Math.cos(delta) * Math.sin(turn);
  return {
    azimuth: (Math.atan2(east, north) / kRadians + 360) % 360,
    altitude: Math.asin(Math.min(1, Math.max(-1, up))) / kRadians,
  };
}

/// Returns the hours of sunrise and sunset. Returns null if the sun does not rise, and 0 to 24 if it does not set.
export function daylight(latitude: number, day: number): [number, number] | null {
  const cosine = -Math.tan(latitude * kRadians) * Math.tan(declination(day) * kRadians);
  if (cosine >= 1) return null;
  if (cosine <= -1) return [0, 24];
  const half = Math.acos(cosine) / kRadians / 15;
  return [12 - half, 12 + half];
}

/// Returns the hour at which the sun of some day stands at or below a position of the sky, and that day's declination.
export function hour_and_declination(
  latitude: number,
  { azimuth, altitude }: SkyPlace,
): { hour: number; declination: number } {
  const [phi, a, h] = [latitude * kRadians, azimuth * kRadians, altitude * kRadians];
  const [east, north, up] = [Math.cos(h) * Math.sin(a), Math.cos(h) * Math.cos(a), Math.sin(h)];
  const toward_pole = Math.sin(phi) * up + Math.cos(phi) * north;
  const along = Math.cos(phi) * up - Math.sin(phi) * north;
  const hour = 12 + Math.atan2(-east, along) / kRadians / 15;
  return {
    hour: Math.min(24, Math.max(0, hour)),
    declination: Math.asin(Math.min(1, Math.max(-1, toward_pole))) / kRadians,
  };
}

/// Returns the day with this declination, or the nearest one, in the same half of the year as another day.
export function day_of(sun: number, near: number): number {
  const wanted = Math.min(kMaxDeclination, Math.max(-kMaxDeclination, sun));
  const rises = near <= kSolstices.summer || near > kSolstices.winter;
  const first = rises ? kSolstices.winter - kDaysOfYear : kSolstices.summer;
  const last = rises ? kSolstices.summer : kSolstices.winter;
  let [best, min] = [near, Infinity];
  for (let day = first; day <= last; day += 1) {
    const away = Math.abs(declination(day) - wanted);
    if (away < min) [best, min] = [day, away];
  }
  return best < 1 ? best + kDaysOfYear : best;
}

/// Returns the day of the year of a date such as 2026-06-21, or null for other texts.
export function day_of_date(date: string): number | null {
  const found = /^(\d{4})-(\d{2})-(\d{2})$/.exec(date);
  if (!found) return null;
  const [year, month, day] = [Number(found[1]), Number(found[2]), Number(found[3])];
  return Math.round((Date.UTC(year, month - 1, day) - Date.UTC(year, 0, 1)) / 86_400_000) + 1;
}

export function date_of_day(day: number, year: number): string {
  return new Date(Date.UTC(year, 0, Math.round(day))).toISOString().slice(0, 10);
}

/// Returns the number of days of a year: 365 or 366.
export function days_of_year(year: number): number {
  return Math.round((Date.UTC(year + 1, 0, 1) - Date.UTC(year, 0, 1)) / 86_400_000);
}

/// Returns a day as text: "21 June", in a year without a leap day.
export function day_text(day: number): string {
  return new Date(Date.UTC(2025, 0, Math.round(day))).toLocaleDateString('en', {
    day: 'numeric',
    month: 'long',
    timeZone: 'UTC',
  });
}

/// Returns an hour as text: "15:30".
export function hour_text(hour: number): string {
  const minutes = Math.round(hour * 60) % 1440;
  return `${Math.floor(minutes / 60)}:${String(minutes % 60).padStart(2, '0')}`;
}

/// Returns the hour of a number or of a text such as "15:30". Returns null for other values.
export function hour_of(value: unknown): number | null {
  if (typeof value === 'number') return value;
  const found = typeof value === 'string' ? /^(\d{1,2}):(\d{2})(?::(\d{2}))?$/.exec(value) : null;
  return found ? Number(found[1]) + Number(found[2]) / 60 + Number(found[3] ?? 0) / 3600 : null;
}
