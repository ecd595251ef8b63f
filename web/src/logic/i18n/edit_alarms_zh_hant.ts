/** What keeps an edit of features from being made: what is wrong, why, and what to do. */
export const EDIT_ALARMS_ZH_HANT: Record<string, [message: string, cause: string, remedy: string]> =
  {
    EDIT_FILE: [
      '無法讀取編輯檔',
      '`--edits` 的檔案不是 JSON，或不合 docs/edit-features.md 所述的格式：版本、操作或成員不明，或值的種類不對。',
      '請更正所指之處。',
    ],
    EDIT_FEATURE_UNKNOWN: [
      '沒有此特徵',
      '編輯指名的特徵、孔或孔群，程式中沒有。',
      '請取用同一程式 `kerf features` 的 id 或 key。',
    ],
    EDIT_LAYER_UNKNOWN: [
      '沒有此層',
      '編輯指名的層或島，該特徵沒有。',
      '層由 1 起算，島由 0 起算，如 `kerf features` 所示。',
    ],
    EDIT_ELEMENT_UNKNOWN: [
      '沒有此元素',
      '編輯指名的元素或轉角，該輪廓沒有。',
      '元素與轉角由 0 起算，依 `kerf features` 所示的正規形式。',
    ],
    EDIT_CALL_UNKNOWN: [
      '沒有此呼叫',
      '編輯指名的呼叫或其引數，程式中沒有。',
      '請取用 `kerf features` 中 `calls` 的 id，以及該呼叫中的字母。',
    ],
    EDIT_OPEN: [
      '輪廓未封閉',
      '輪廓的最後一項編輯之後，兩個相鄰元素沒有相接。',
      '請將兩者連接，或在其間加入元素。',
    ],
    EDIT_CROSSES_ITSELF: [
      '輪廓自相交',
      '兩個元素相交，或島不在輪廓之內，或與另一島沒有分開。',
      '請移動其中之一。',
    ],
    EDIT_NO_AREA: ['輪廓沒有圍出面積', '輪廓所剩的部分沒有面積。', '若要去除該特徵，請將它刪除。'],
    EDIT_DOES_NOT_FIT: [
      '圓角或倒角放不下',
      '圓角或倒角所需的元素長度超過現有長度。',
      '請取較小的值。',
    ],
    EDIT_NO_MEETING: [
      '元素不相交',
      '要連接的兩個元素無論延長多少都沒有共同點。',
      '請在其間加入元素。',
    ],
    EDIT_TOOL_TOO_BIG: [
      '刀具放不進去',
      '刀具比輪廓寬，或內側轉角雖為圓角，半徑卻小於刀具半徑。',
      '請將該轉角保留為尖角，或使用較小的刀具。',
    ],
    EDIT_COLLIDES: [
      '會切入另一特徵',
      '編輯所切除的部分，在其深度上碰到另一特徵。',
      '請與它保持距離，或使用 `--allow-collision`。',
    ],
    EDIT_UNDERCUT: [
      '上層小於下層',
      '上層會小於下層，任何刀具都無法由上方切出。',
      '請不要寫 `"layers":"only"`：其他各層便會跟隨。',
    ],
    EDIT_SHARED: [
      '多個呼叫共用的單節',
      '這些單節由多個呼叫執行，而編輯沒有說明是哪些。',
      '`"scope":"all"` 會編輯全部。',
    ],
    EDIT_IN_LOOP: [
      '由迴圈產生的輪廓',
      '這些單節由 WHILE、GOTO 或 G66 重複執行。',
      '`"unroll":true` 會將迴圈寫成一般單節。',
    ],
    EDIT_EXPRESSION: [
      '由運算式產生的輪廓',
      '單節中的數值是變數或運算式。',
      '請以 `argument` 操作更改呼叫的引數，或寫 `"unroll":true`。',
    ],
    EDIT_OTHER_FILE: [
      '單節在另一檔案中',
      '這些單節位於程式庫的檔案中。',
      '請以 `--output-library` 指定放置更改後檔案的資料夾。',
    ],
    EDIT_NOT_EDITABLE: [
      '不能如此編輯',
      '該特徵或其單節不允許此項編輯。',
      '訊息中說明了可行的做法。',
    ],
    EDIT_UNROLL_VARIABLES: [
      '後面的單節讀取該變數',
      '要展開的迴圈或呼叫設定了後面會讀取的變數。',
      '請改為編輯引數。',
    ],
    EDIT_TOOL_UNKNOWN: ['沒有此刀具', '編輯指名的刀具沒有任何描述。', '請以 `--tools` 描述它。'],
    EDIT_TOOL_SHARED: [
      '刀具還切削其他特徵',
      '該刀具的加工也切削沒有編輯的部分。',
      '請一併編輯那些部分，或寫 `"split":true`。',
    ],
    EDIT_ORDER: [
      '不是同一把刀具',
      '要調換順序的兩個特徵由兩把刀具切削。',
      '特徵只能在同一加工之內調換位置。',
    ],
    EDIT_LEAVES_REST: [
      '留有未切削的材料',
      '新的刀路留下刀具本可到達的材料。',
      '若要留下，請使用 `--allow-rest`。',
    ],
    EDIT_NOT_VERIFIED: [
      '合併後的程式切削結果與要求不符',
      '已執行含編輯的程式，其切削結果與編輯所述不同。沒有寫入任何檔案。',
      '請分成較小的步驟更改，或手動更改。',
    ],
    EDIT_CHANGED_SINCE: [
      '文字不是編輯所留下的',
      '在要復原的編輯之後，程式又被更改。',
      '請取用編輯所留下的文字。',
    ],
    EDIT_NO_CHANGE: [
      '沒有任何更改',
      '程式已有此輪廓：輸出與輸入相同。',
      '若應有更改，請檢查編輯所指名的特徵、層與數值。',
    ],
    EDIT_OUTSIDE_STOCK: [
      '超出毛坯',
      '編輯所切除的部分，有一部分位於毛坯之外。',
      '若毛坯與此不同，請檢查 `--stock` 與輪廓的座標。',
    ],
    EDIT_SPEEDS_STAY: [
      '轉速與進給仍屬原刀具',
      '現在由另一把刀具切削；S 與 F 仍是原刀具的數值。',
      '進給可用 `feed` 編輯更改，S 請手動更改。',
    ],
    EDIT_TOOL_UNUSED: [
      '刀具沒有加工',
      '該刀具已沒有任何特徵；換刀及其開頭仍留在程式中。',
      '若不再需要該刀具，請手動刪除換刀與其開頭。',
    ],
  };
