// SPDX-License-Identifier: Apache-2.0
// All requests, answers and messages by name.
// `meristem_studio_protocol` writes this file from apps/studio/protocol.
import type {
  DragAnswer,
  DragRequest,
  EditAnswer,
  EditRequest,
  OpenAnswer,
  OpenRequest,
  SpliceRequest,
  TextAnswer,
  TextRequest,
} from './document.ts';
import type {
  CommandAnswer,
  CommandRequest,
  ExportAnswer,
  ExportRequest,
  StillsAnswer,
  StillsRequest,
} from './export.ts';
import type {
  Elsewhere,
  FilesAnswer,
  FilesRequest,
  ModelsAnswer,
  PartAnswer,
  PartRequest,
  PartsAnswer,
  PartsRequest,
  PictureAnswer,
  PictureRequest,
  SaveAnswer,
  SaveRequest,
} from './files.ts';
import type { MeasureRowsAnswer, MeasuresAnswer, MeasuresRequest, SweepAnswer, SweepRequest } from './measures.ts';
import type {
  ClocksAnswer,
  ClocksRequest,
  CloudAnswer,
  CloudRequest,
  CurvesAnswer,
  CurvesRequest,
  GrammarAnswer,
  GrammarRequest,
  OverlaysAnswer,
  OverlaysRequest,
  StandAnswer,
  StandRequest,
  WorkedOutAnswer,
  WorkedOutRequest,
} from './plant.ts';
import type { InstanceAnswer, InstanceRequest, OperationsAnswer, OperationsRequest, ShootRequest } from './shoots.ts';
import type { CancelRequest, Failed, Grown, Hello, PauseRequest, ShownRequest, ViewRequest, Working } from './view.ts';

/// The members of each request.
export interface Requests {
  open: OpenRequest;
  splice: SpliceRequest;
  text: TextRequest;
  edit: EditRequest;
  drag: DragRequest;
  view: ViewRequest;
  shown: ShownRequest;
  all: object;
  cancel: CancelRequest;
  continue: object;
  pause: PauseRequest;
  files: FilesRequest;
  save: SaveRequest;
  models: object;
  parts: PartsRequest;
  part: PartRequest;
  picture: PictureRequest;
  export: ExportRequest;
  command: CommandRequest;
  stills: StillsRequest;
  grammar: GrammarRequest;
  overlays: OverlaysRequest;
  stand: StandRequest;
  worked_out: WorkedOutRequest;
  curves: CurvesRequest;
  cloud: CloudRequest;
  clocks: ClocksRequest;
  instance: InstanceRequest;
  shoot: ShootRequest;
  operations: OperationsRequest;
  measures: MeasuresRequest;
  measure_rows: object;
  sweep: SweepRequest;
}

/// The members of each answer.
export interface Answers {
  open: OpenAnswer;
  splice: TextAnswer;
  text: TextAnswer;
  edit: EditAnswer;
  drag: DragAnswer;
  view: object;
  shown: object;
  all: object;
  cancel: object;
  continue: object;
  pause: object;
  files: FilesAnswer;
  save: SaveAnswer;
  models: ModelsAnswer;
  parts: PartsAnswer;
  part: PartAnswer;
  picture: PictureAnswer;
  export: ExportAnswer;
  command: CommandAnswer;
  stills: StillsAnswer;
  grammar: GrammarAnswer;
  overlays: OverlaysAnswer;
  stand: StandAnswer;
  worked_out: WorkedOutAnswer;
  curves: CurvesAnswer;
  cloud: CloudAnswer;
  clocks: ClocksAnswer;
  instance: InstanceAnswer;
  shoot: InstanceAnswer;
  operations: OperationsAnswer;
  measures: MeasuresAnswer;
  measure_rows: MeasureRowsAnswer;
  sweep: SweepAnswer;
}

/// A message that the server sends on its own.
export type ServerMessage = Hello | Working | Grown | Failed | Elsewhere;
