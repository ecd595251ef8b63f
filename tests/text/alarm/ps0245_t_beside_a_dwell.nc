O1 (PS0245: T in a G04 block)
G04 X1. T5 (expect alarm PS0245 at T5)
M30
