// SPDX-License-Identifier: Apache-2.0
// The type of any JSON in messages.
export type { Json } from '../document/json.ts';
