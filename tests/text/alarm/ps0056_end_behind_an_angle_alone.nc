(run with: --machine lathe2)
O1 (PS0056: no line comes)
G98 G00 X20. Z0.
G01 ,A170. F100
M30 (expect alarm PS0056)
M30
