O1 (PS0053: one corner, two shapes)
G01 X10. F100 ,C1. ,R2. (expect alarm PS0053 at ,R2.)
Y10.
M30
