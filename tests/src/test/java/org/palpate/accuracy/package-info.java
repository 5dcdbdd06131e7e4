/** Tests of the accuracy of the solvers' forces, on analytic surfaces and on scans. */
package org.palpate.accuracy;
