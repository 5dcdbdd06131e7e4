/**
 * A tool of many points: one call tests them all for collision, or moves an interaction point for
 * each.
 *
 * <p>Uses {@code proxy}. Owned scratch, no thread of its own: ranges of points may be worked on by
 * several threads at once, each with its own {@link org.palpate.proxy.shell.ShellCollider}. Tool
 * and grid millimetres in, grid coordinates out. Source: Vlasov, Friese, Wolter 2013, section 7,
 * the outlook: a controlled object as a set of points.
 */
package org.palpate.proxy.shell;
