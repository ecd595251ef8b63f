O1 (REF-4: G80 first)
G90 G00 Z5.
G81 X0 Y0 Z-5. R1. F100
G28 Z0 (expect alarm PS0044 at G28)
M30
