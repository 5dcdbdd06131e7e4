/**
 * Tests of every command from its arguments to its exit code, lines, tables and reports.
 *
 * <p>Uses {@code app} as a person does. Commands run in this JVM, or in a JVM of their own if the
 * JVM itself is tested.
 */
package org.palpate.endtoend;
