(run with: --machine lathe2)
O1 (PS0053: a line has one angle)
G98 G00 X20. Z0.
G01 Z-20. ,A170. ,A135. F100 (expect alarm PS0053 at ,A135.)
M30
