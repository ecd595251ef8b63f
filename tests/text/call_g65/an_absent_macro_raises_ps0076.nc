O1 (CALL-3: there is no O99)
G65 P99 (expect alarm PS0076 at P99)
M30
