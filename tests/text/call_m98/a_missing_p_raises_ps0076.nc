O1 (CALL-3: M98 alone calls nothing)
M98 (expect alarm PS0076)
M30
