O1 (REF-3: no G28 before)
G29 X20. (expect alarm PS0305)
M30
