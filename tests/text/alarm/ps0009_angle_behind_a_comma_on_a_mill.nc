O1 (PS0009: lines by their angle are a lathe's)
G01 X10. ,A30. F100 (expect alarm PS0009 at ,A30.)
M30
