// SPDX-License-Identifier: Apache-2.0
// The tools of the page, by their classes.

/// The class of a tool. Panels find a tool by its class.
export type ToolKind<T> = abstract new (...parts: never[]) => T;

export class Tools {
  private readonly all_ = new Map<unknown, object>();

  /// Adds a tool and returns it.
  add<T extends object>(tool: T): T {
    this.all_.set(tool.constructor, tool);
    return tool;
  }

  /// Returns the tool of a class. Throws if no tool has this class.
  find<T>(kind: ToolKind<T>): T {
    const tool = this.all_.get(kind);
    if (!tool) throw new Error(`the page has no ${kind.name}`);
    return tool as T;
  }
}
