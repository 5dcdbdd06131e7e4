package org.palpate.rigid.tool;

/** The closed solid that a tool's points were sampled from, in the tool frame. Immutable. */
@FunctionalInterface
public interface ToolSolid {
  /** Whether the solid holds the point, tool frame, mm. */
  boolean contains(double x, double y, double z);
}
