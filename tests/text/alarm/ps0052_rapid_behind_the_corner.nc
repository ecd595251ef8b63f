O1 (PS0052: a corner lies between two cuts)
G01 X10. F100 ,C1.
G00 Y10. (expect alarm PS0052)
M30
