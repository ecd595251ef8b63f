O1 (PS0076: there is no O1234)
M98 P1234 (expect alarm PS0076 at P1234)
M30
