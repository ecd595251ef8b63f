O1 (PS0005: an address without value)
G00 X1. Y (expect alarm PS0005 at Y)
M30
