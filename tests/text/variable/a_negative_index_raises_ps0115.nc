O1 (VAR-2: there is no variable -1)
#100=#[-1] (expect alarm PS0115)
M30
