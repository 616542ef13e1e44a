// SPDX-License-Identifier: Apache-2.0
// Messages about the connection, the view and the growth of the document.
// `meristem_studio_protocol` writes this file from apps/studio/protocol.
import type { Fault } from './document.ts';

/// The growth step that is shown.
export interface ShownGrowth {
  /// Growth step of the plants. Null: the last step.
  step?: number | null;
  /// True: growth is recorded, for overlays and for the `steps` of `grown`.
  recorded: boolean;
  /// Component whose plants the step is for. Null: all plants.
  of?: string | null;
}

/// Sets what is shown. Changes come as a packet.
export interface ViewRequest {
  /// Maximum number of triangles while something moves, at first 60000.
  drag_triangles?: number | null;
  /// Maximum number of triangles at rest, at first 250000.
  rest_triangles?: number | null;
  /// True: shows surfaces. At first true.
  surface?: boolean | null;
  /// True: shows skeletons. At first false.
  skeleton?: boolean | null;
  /// Time of the document, at first 0.
  time?: number | null;
  /// The growth step that is shown.
  growth?: ShownGrowth | null;
}

/// Reports that a packet is shown. The next packet comes only after this message.
export interface ShownRequest {
  /// Number of the packet.
  packet: number;
}

/// Cancels the work of one request, or the growth. The cancelled request is refused with `cancelled`. After a cancelled
/// growth, the next change grows again.
export interface CancelRequest {
  /// The `id` of the request, whose work runs, waits or reads the text. Missing: the growth.
  re?: number | null;
}

/// Pauses or resumes growth.
export interface PauseRequest {
  /// True: no new growth begins.
  paused: boolean;
}

/// A format of exported files.
export interface Format {
  /// Ending of its files, with the dot.
  ending: string;
  /// Description.
  doc: string;
  /// True: it can have levels of detail.
  levels: boolean;
  /// True: it can store instances.
  instances: boolean;
}

/// An overlay that can be shown over the plant.
export interface OverlayPart {
  /// Name in the request `overlays`.
  name: string;
  /// Name for users.
  title: string;
  /// Description.
  doc: string;
  /// True: it needs recorded growth.
  recorded: boolean;
}

/// The limits of the server.
export interface StudioLimits {
  /// Maximum size of one message of the page.
  message_bytes: number;
  /// Maximum number of messages within one second.
  messages_per_second: number;
  /// Time for one growth, export or measurement.
  job_seconds: number;
  /// Time for one film.
  film_seconds: number;
  /// Memory of the whole program while a job runs.
  memory_bytes: number;
  /// Maximum number of pages.
  connections: number;
}

/// The first message of a connection.
export interface Hello {
  is: 'hello';
  /// Version of the protocol: 1.
  protocol: number;
  /// Version of the program.
  version: string;
  /// Name of the folder whose documents can be opened.
  root: string;
  /// Identifies the folder among folders of its name.
  root_key: string;
  /// Path of the document to open first. Null: none.
  document: string | null;
  /// Name of the model to open first. Null: none.
  model: string | null;
  /// Formats of exported files.
  formats: Format[];
  /// Overlays that can be shown over the plant.
  overlays: OverlayPart[];
  /// Limits of the server.
  limits: StudioLimits;
}

/// Progress of a job, at most ten times a second.
export interface Working {
  is: 'working';
  /// The job. `question` stands for requests about the last growth.
  job: 'grow' | 'export' | 'measure' | 'sweep' | 'stills' | 'grammar' | 'picture' | 'question';
  /// The `id` of the request. Missing: the growth.
  re?: number;
  /// Present stage of the job. Null: the job is over.
  stage: string | null;
  /// Finished share of the stage.
  share: number;
}

/// A stage of the growth and its time.
export interface GrownStage {
  /// Name of the stage.
  name: string;
  /// Time, milliseconds.
  ms: number;
}

/// The reuse of one kind of result.
export interface GrownReuse {
  /// Kind of result: instances, grown skeletons and so on.
  what: string;
  /// Number of new results.
  made: number;
  /// Number of results from earlier growths.
  reused: number;
}

/// The size of a component in the scene.
export interface ComponentCount {
  /// Number of instances.
  instances: number;
  /// Number of triangles of all instances.
  triangles: number;
}

/// A grown plant. It comes right before each packet.
export interface Grown {
  is: 'grown';
  /// Hash of the text that has grown.
  hash: string;
  /// True: with the values of a drag.
  dragged: boolean;
  /// Times of the stages. Reused stages are left out.
  stages: GrownStage[];
  /// How much was reused. Kinds that the plant does not need are left out.
  reuse: GrownReuse[];
  /// Number of nodes of all skeletons.
  nodes: number;
  /// Number of instances.
  instances: number;
  /// Number of triangles. Null: a coarser level is shown.
  triangles: number | null;
  /// Number of instances by component, without omitted ones. Null: a drag.
  placed: Record<string, number> | null;
  /// Size of each component. Null: a coarser level is shown.
  components: Record<string, ComponentCount> | null;
  /// Growth step that is shown.
  step: number;
  /// Number of steps of the plants that the step is for. Null: growth is not recorded.
  steps: number | null;
  /// Number of steps of the plants of each component that grows or places some. Null: growth is not recorded.
  growing: Record<string, number> | null;
}

/// A growth that failed. The shown plant stays, even if it is a draft.
export interface Failed {
  is: 'failed';
  /// The job: `grow`.
  job: 'grow' | 'export' | 'measure' | 'sweep' | 'stills' | 'grammar' | 'picture' | 'question';
  /// Hash of the text.
  hash: string;
  /// Reason of the failure.
  message: string;
  /// Reached limits of the document, and numbers that are not finite.
  faults?: Fault[];
  /// Name of the reached limit of the server.
  limit?: string;
  /// True: the work reached `job_seconds`, and `continue` continues it.
  continues?: boolean;
}
