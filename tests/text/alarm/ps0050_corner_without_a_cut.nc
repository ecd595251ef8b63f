O1 (PS0050: a corner radius at the end of a rapid)
G00 X10. ,R2. (expect alarm PS0050 at ,R2.)
Y10.
M30
