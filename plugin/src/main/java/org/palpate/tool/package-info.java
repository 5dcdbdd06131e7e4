/**
 * Makes rigid tools from what a user writes: shapes, and segments of volume files.
 *
 * <p>Uses {@code rigid} and {@code io}. One thread. World millimetres.
 */
package org.palpate.tool;
