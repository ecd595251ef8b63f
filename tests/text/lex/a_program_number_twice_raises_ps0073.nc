O1 (LEX-3: a stored number cannot be stored again)
M98 P2
M30
O2
M99
O2 (expect alarm PS0073)
M99
