O1 (PS0003: 10 digits in least increments)
G00 X1234567. (expect alarm PS0003 at X1234567.)
M30
