O1 (PS0009: mill3 has no C axis)
G00 C90. (expect alarm PS0009 at C90.)
M30
