O1 (PS0305: G29 without G28)
G29 X0 (expect alarm PS0305)
M30
