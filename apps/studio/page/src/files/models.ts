// SPDX-License-Identifier: Apache-2.0
// The shipped plants.
import { useEffect, useState } from 'react';

import { use_page } from '../page/use_page.ts';
import type { ShippedModel } from '../server/protocol.ts';

/// Returns the shipped plants. The list is empty until the server has answered.
export function use_models(): ShippedModel[] {
  const page = use_page();
  const [models, set_models] = useState<ShippedModel[]>([]);
  useEffect(() => {
    page.connection
      .request('models')
      .then((answer) => set_models(answer.models))
      .catch((fault: Error) => page.notify(fault.message, true));
  }, [page]);
  return models;
}
