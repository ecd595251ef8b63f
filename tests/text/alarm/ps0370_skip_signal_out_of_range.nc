O1 (PS0370: there is no skip signal 100)
G31 P100 X10. F100 (expect alarm PS0370 at P100)
M30
