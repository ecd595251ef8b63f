O1 (PS0311: the name has no end)
M98 <NOWHERE (expect alarm PS0311)
M30
