O1 (PS0010: there is no G777)
G777 (expect alarm PS0010 at G777)
M30
